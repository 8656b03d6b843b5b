# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Parameters of joints, by PyODE's names: of the first, second and third axis; those that begin small are older."""
from __future__ import annotations

from .. import c

ParamGroup = c.dParamGroup
paramLoStop = ParamLoStop = c.dParamLoStop
paramHiStop = ParamHiStop = c.dParamHiStop
paramVel = ParamVel = c.dParamVel
paramFMax = ParamFMax = c.dParamFMax
paramFudgeFactor = ParamFudgeFactor = c.dParamFudgeFactor
paramBounce = ParamBounce = c.dParamBounce
paramCFM = ParamCFM = c.dParamCFM
paramStopERP = ParamStopERP = c.dParamStopERP
paramStopCFM = ParamStopCFM = c.dParamStopCFM
paramSuspensionERP = ParamSuspensionERP = c.dParamSuspensionERP
paramSuspensionCFM = ParamSuspensionCFM = c.dParamSuspensionCFM
ParamLoStop2 = c.dParamLoStop + ParamGroup
ParamHiStop2 = c.dParamHiStop + ParamGroup
ParamVel2 = c.dParamVel + ParamGroup
ParamFMax2 = c.dParamFMax + ParamGroup
ParamFudgeFactor2 = c.dParamFudgeFactor + ParamGroup
ParamBounce2 = c.dParamBounce + ParamGroup
ParamCFM2 = c.dParamCFM + ParamGroup
ParamStopERP2 = c.dParamStopERP + ParamGroup
ParamStopCFM2 = c.dParamStopCFM + ParamGroup
ParamSuspensionERP2 = c.dParamSuspensionERP + ParamGroup
ParamSuspensionCFM2 = c.dParamSuspensionCFM + ParamGroup
ParamLoStop3 = c.dParamLoStop + 2 * ParamGroup
ParamHiStop3 = c.dParamHiStop + 2 * ParamGroup
ParamVel3 = c.dParamVel + 2 * ParamGroup
ParamFMax3 = c.dParamFMax + 2 * ParamGroup
ParamFudgeFactor3 = c.dParamFudgeFactor + 2 * ParamGroup
ParamBounce3 = c.dParamBounce + 2 * ParamGroup
ParamCFM3 = c.dParamCFM + 2 * ParamGroup
ParamStopERP3 = c.dParamStopERP + 2 * ParamGroup
ParamStopCFM3 = c.dParamStopCFM + 2 * ParamGroup
ParamSuspensionERP3 = c.dParamSuspensionERP + 2 * ParamGroup
ParamSuspensionCFM3 = c.dParamSuspensionCFM + 2 * ParamGroup
