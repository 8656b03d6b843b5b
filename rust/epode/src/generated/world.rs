// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by rust/tools/generate.py from the public headers.
#![allow(clippy::useless_conversion, clippy::unnecessary_cast, clippy::doc_lazy_continuation, clippy::doc_overindented_list_items)]
use crate::prelude::*;

impl World {
    /// What dWorldSetBehaviour has set; at first 100 or what the environment says.
    ///
    /// C: `dWorldGetBehaviour`.
    pub fn behaviour(&self) -> Behaviour {
        let r = sure(|| unsafe { sys::dWorldGetBehaviour(self.raw()) });
        let r = r as i32;
        Behaviour::of_number(r)
    }

    /// 1 if steps are diagnosed, else 0.
    ///
    /// C: `dWorldGetDiagnosisMode`.
    pub fn diagnosis_mode(&self) -> bool {
        let r = sure(|| unsafe { sys::dWorldGetDiagnosisMode(self.raw()) });
        r != 0
    }

    /// Copy the settings to \*settings. Returns 1; 0, and the defaults, if there are
    /// none.
    ///
    /// C: `dWorldGetEventSettings`.
    pub fn event_settings(&self) -> Option<EventSettings> {
        let mut settings = EventSettings::empty();
        let r = sure(|| unsafe { sys::dWorldGetEventSettings(self.raw(), &mut settings) });
        (r != 0).then(|| EventSettings::from_raw(&settings, self.shared()))
    }

    /// Returns how many events of the last step did not fit into the list; those that
    /// persist are the first to go.
    ///
    /// C: `dWorldGetLostEvents`.
    pub fn lost_events(&self) -> i32 {
        sure(|| unsafe { sys::dWorldGetLostEvents(self.raw()) })
    }

    /// 1 if steps are reported, else 0.
    ///
    /// C: `dWorldGetStepReportMode`.
    pub fn step_report_mode(&self) -> bool {
        let r = sure(|| unsafe { sys::dWorldGetStepReportMode(self.raw()) });
        r != 0
    }

    /// Copies the report of the world's last step to \*report. Returns 1; 0 while the mode is off and before the
    /// first step since it was switched on.
    ///
    /// C: `dWorldGetStepReport`.
    pub fn step_report(&self) -> Option<StepReport> {
        let mut report = StepReport::empty();
        let r = sure(|| unsafe { sys::dWorldGetStepReport(self.raw(), &mut report) });
        (r != 0).then(|| StepReport::from_raw(&report, self.shared()))
    }

    /// Copies to \*report what the last step did in one island, 0 \<= island \< dWorldStepReport::islands. Islands
    /// are in the order in which ODE finds them, from the youngest body on. Returns as dWorldGetStepReport
    /// does. Refused: another index.
    ///
    /// C: `dWorldGetIslandStepReport`.
    pub fn island_step_report(&self, island: i32) -> Result<Option<IslandStepReport>> {
        let mut report = IslandStepReport::empty();
        let r = call(|| unsafe { sys::dWorldGetIslandStepReport(self.raw(), island, &mut report) })?;
        Ok((r != 0).then(|| IslandStepReport::from_raw(&report, self.shared())))
    }

    /// 1 if steps keep one, else 0.
    ///
    /// C: `dWorldGetEnergyLedgerMode`.
    pub fn energy_ledger_mode(&self) -> bool {
        let r = sure(|| unsafe { sys::dWorldGetEnergyLedgerMode(self.raw()) });
        r != 0
    }

    /// Copy the ledger of the world's last step to \*ledger.
    ///
    /// C: `dWorldGetEnergyLedger`.
    pub fn energy_ledger(&self) -> Option<EnergyLedger> {
        let mut ledger = EnergyLedger::empty();
        let r = sure(|| unsafe { sys::dWorldGetEnergyLedger(self.raw(), &mut ledger) });
        (r != 0).then(|| EnergyLedger::from_raw(&ledger, self.shared()))
    }

    /// Copy that of one island to \*ledger, 0 \<= island \<
    /// dEnergyLedger::islands.
    ///
    /// Both return 1; 0 while the mode is off and before the first step since it was switched on.
    ///
    /// C: `dWorldGetIslandEnergyLedger`.
    pub fn island_energy_ledger(&self, island: i32) -> Result<Option<EnergyLedger>> {
        let mut ledger = EnergyLedger::empty();
        let r = call(|| unsafe { sys::dWorldGetIslandEnergyLedger(self.raw(), island, &mut ledger) })?;
        Ok((r != 0).then(|| EnergyLedger::from_raw(&ledger, self.shared())))
    }

    /// Returns how many steps can be taken back now. A step without memory for its state
    /// sends a message, and the history begins again: then 0.
    ///
    /// What the history has.
    ///
    /// C: `dWorldGetHistoryFrames`.
    pub fn history_frames(&self) -> i32 {
        sure(|| unsafe { sys::dWorldGetHistoryFrames(self.raw()) })
    }

    /// Returns the bytes that the states take, without objects that may come back.
    ///
    /// What the history has.
    ///
    /// C: `dWorldGetHistorySize`.
    pub fn history_size(&self) -> usize {
        sure(|| unsafe { sys::dWorldGetHistorySize(self.raw()) })
    }

    /// The number that dWorldSetStepThreads has set, 1 at first.
    ///
    /// C: `dWorldGetStepThreads`.
    pub fn step_threads(&self) -> i32 {
        sure(|| unsafe { sys::dWorldGetStepThreads(self.raw()) })
    }

    /// The factor that dWorldSetStepWarmStarting has set, 1 at first.
    ///
    /// C: `dWorldGetStepWarmStarting`.
    pub fn step_warm_starting(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetStepWarmStarting(self.raw()) })
    }

    /// The mode that dWorldSetFrictionCone has set, 0 at first.
    ///
    /// C: `dWorldGetFrictionCone`.
    pub fn friction_cone(&self) -> bool {
        let r = sure(|| unsafe { sys::dWorldGetFrictionCone(self.raw()) });
        r != 0
    }

    /// The mode that dWorldSetManifoldFriction has set, 0 at first.
    ///
    /// C: `dWorldGetManifoldFriction`.
    pub fn manifold_friction(&self) -> bool {
        let r = sure(|| unsafe { sys::dWorldGetManifoldFriction(self.raw()) });
        r != 0
    }

    /// The mode that dWorldSetExactRotation has set, 0 at first.
    ///
    /// C: `dWorldGetExactRotation`.
    pub fn exact_rotation(&self) -> bool {
        let r = sure(|| unsafe { sys::dWorldGetExactRotation(self.raw()) });
        r != 0
    }

    /// The mode that dWorldSetJointCoordinates has set, 0 at first.
    ///
    /// C: `dWorldGetJointCoordinates`.
    pub fn joint_coordinates(&self) -> i32 {
        sure(|| unsafe { sys::dWorldGetJointCoordinates(self.raw()) })
    }

    /// The number that dWorldSetExactSubsteps has set, 1 at first.
    ///
    /// C: `dWorldGetExactSubsteps`.
    pub fn exact_substeps(&self) -> i32 {
        sure(|| unsafe { sys::dWorldGetExactSubsteps(self.raw()) })
    }

    /// The number that dWorldSetStepProjection has set, 0 at first.
    ///
    /// C: `dWorldGetStepProjection`.
    pub fn step_projection(&self) -> i32 {
        sure(|| unsafe { sys::dWorldGetStepProjection(self.raw()) })
    }

    /// The tolerance that dWorldSetStepProjectionTolerance has set; at
    /// first 1e-4, 1e-3 in single precision.
    ///
    /// C: `dWorldGetStepProjectionTolerance`.
    pub fn step_projection_tolerance(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetStepProjectionTolerance(self.raw()) })
    }

    /// What dWorldSetHybridStepper has set, dStepperHybrid at first.
    ///
    /// C: `dWorldGetHybridStepper`.
    pub fn hybrid_stepper(&self) -> Stepper {
        let r = sure(|| unsafe { sys::dWorldGetHybridStepper(self.raw()) });
        let r = r as i32;
        Stepper::of_number(r)
    }

    /// The number that dWorldSetHybridSubsteps has set, 4 at first.
    ///
    /// C: `dWorldGetHybridSubsteps`.
    pub fn hybrid_substeps(&self) -> i32 {
        sure(|| unsafe { sys::dWorldGetHybridSubsteps(self.raw()) })
    }

    /// What dWorldSetHybridBudget has set, 1 at first.
    ///
    /// C: `dWorldGetHybridBudget`.
    pub fn hybrid_budget(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetHybridBudget(self.raw()) })
    }

    /// Write the world's gravity, m/s^2, to gravity: 3 reals, world frame.
    ///
    /// C: `dWorldGetGravity`.
    pub fn gravity(&self) -> Vec3 {
        let mut gravity: [Real; 4] = [0.0; 4];
        sure(|| unsafe { sys::dWorldGetGravity(self.raw(), gravity.as_mut_ptr()) });
        vec3(gravity)
    }

    /// The world's error reduction parameter, 0.2 at first.
    ///
    /// C: `dWorldGetERP`.
    pub fn erp(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetERP(self.raw()) })
    }

    /// The world's constraint force mixing; at first 1e-10, 1e-5 in single precision.
    ///
    /// C: `dWorldGetCFM`.
    pub fn cfm(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetCFM(self.raw()) })
    }

    /// The most threads that work on a step; 0: no limit.
    ///
    /// C: `dWorldGetStepIslandsProcessingMaxThreadCount`.
    pub fn step_islands_processing_max_thread_count(&self) -> u32 {
        sure(|| unsafe { sys::dWorldGetStepIslandsProcessingMaxThreadCount(self.raw()) })
    }

    /// The constant force (N, 3 reals written) that gives the impulse (ix, iy, iz), N s, within one step of
    /// stepsize seconds, which must not be 0: impulse / stepsize.
    ///
    /// C: `dWorldImpulseToForce`; `impulse` is (ix, iy, iz).
    pub fn impulse_to_force(&self, stepsize: Real, impulse: Vec3) -> Result<Vec3> {
        let mut force: [Real; 4] = [0.0; 4];
        call(|| unsafe { sys::dWorldImpulseToForce(self.raw(), stepsize, impulse[0], impulse[1], impulse[2], force.as_mut_ptr()) })?;
        Ok(vec3(force))
    }

    /// How many iterations dWorldQuickStep makes, 20 at first.
    ///
    /// C: `dWorldGetQuickStepNumIterations`.
    pub fn quick_step_num_iterations(&self) -> i32 {
        sure(|| unsafe { sys::dWorldGetQuickStepNumIterations(self.raw()) })
    }

    /// The factor of over-relaxation of dWorldQuickStep, 1.3 at first.
    ///
    /// C: `dWorldGetQuickStepW`.
    pub fn quick_step_w(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetQuickStepW(self.raw()) })
    }

    /// The greatest velocity that a contact may use to undo penetration,
    /// m/s; dInfinity at first.
    ///
    /// C: `dWorldGetContactMaxCorrectingVel`.
    pub fn contact_max_correcting_vel(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetContactMaxCorrectingVel(self.raw()) })
    }

    /// The depth of penetration that contacts leave alone, m; 0 at first.
    ///
    /// C: `dWorldGetContactSurfaceLayer`.
    pub fn contact_surface_layer(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetContactSurfaceLayer(self.raw()) })
    }

    /// The linear speed up to which new bodies count as idle, m/s; 0.01
    /// at first.
    ///
    /// C: `dWorldGetAutoDisableLinearThreshold`.
    pub fn auto_disable_linear_threshold(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetAutoDisableLinearThreshold(self.raw()) })
    }

    /// The angular speed up to which new bodies count as idle, rad/s;
    /// 0.01 at first.
    ///
    /// C: `dWorldGetAutoDisableAngularThreshold`.
    pub fn auto_disable_angular_threshold(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetAutoDisableAngularThreshold(self.raw()) })
    }

    /// Over how many steps the velocities of new bodies are averaged,
    /// 1 at first.
    ///
    /// C: `dWorldGetAutoDisableAverageSamplesCount`.
    pub fn auto_disable_average_samples_count(&self) -> i32 {
        sure(|| unsafe { sys::dWorldGetAutoDisableAverageSamplesCount(self.raw()) })
    }

    /// How many idle steps new bodies need before they are disabled, 10 at first.
    ///
    /// C: `dWorldGetAutoDisableSteps`.
    pub fn auto_disable_steps(&self) -> i32 {
        sure(|| unsafe { sys::dWorldGetAutoDisableSteps(self.raw()) })
    }

    /// How much idle time new bodies need before they are disabled, s; 0 at first.
    ///
    /// C: `dWorldGetAutoDisableTime`.
    pub fn auto_disable_time(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetAutoDisableTime(self.raw()) })
    }

    /// Non-zero if new bodies disable themselves, else 0.
    ///
    /// C: `dWorldGetAutoDisableFlag`.
    pub fn auto_disable_flag(&self) -> bool {
        let r = sure(|| unsafe { sys::dWorldGetAutoDisableFlag(self.raw()) });
        r != 0
    }

    /// The linear speed from which on damping acts on new bodies, m/s; 0.01
    /// at first.
    ///
    /// C: `dWorldGetLinearDampingThreshold`.
    pub fn linear_damping_threshold(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetLinearDampingThreshold(self.raw()) })
    }

    /// The angular speed from which on damping acts on new bodies, rad/s;
    /// 0.01 at first.
    ///
    /// C: `dWorldGetAngularDampingThreshold`.
    pub fn angular_damping_threshold(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetAngularDampingThreshold(self.raw()) })
    }

    /// The scale of linear damping of new bodies, 0 at first.
    ///
    /// C: `dWorldGetLinearDamping`.
    pub fn linear_damping(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetLinearDamping(self.raw()) })
    }

    /// The scale of angular damping of new bodies, 0 at first.
    ///
    /// C: `dWorldGetAngularDamping`.
    pub fn angular_damping(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetAngularDamping(self.raw()) })
    }

    /// The angular speed that new bodies are held to, rad/s; dInfinity at first.
    ///
    /// C: `dWorldGetMaxAngularSpeed`.
    pub fn max_angular_speed(&self) -> Real {
        sure(|| unsafe { sys::dWorldGetMaxAngularSpeed(self.raw()) })
    }
}

impl World {
    /// Choose how the steps of the world behave: a version of dBehaviour. dBehaviour016:
    /// dWorldQuickStep sweeps in ODE's order, drawn from dRand, from zero and on one thread (states do not hold
    /// what dRandGetSeed returns); bodies fall asleep one by one; finite rotations with an axis are ODE's. At
    /// first dBehaviour1, or what the environment says: EPODE\_BEHAVIOUR=0.16 ./program.
    ///
    /// C: `dWorldSetBehaviour`.
    pub fn set_behaviour(&mut self, version: Behaviour) -> Result<()> {
        call(|| unsafe { sys::dWorldSetBehaviour(self.raw(), version.number()) })
    }

    /// Switch the diagnosis of steps on (mode 1) or off (0, the default), which forgets
    /// what has been found. While it is on a step takes longer; its results are the same bits. Other values are
    /// refused, as is a call during a step and one that finds no memory.
    ///
    /// C: `dWorldSetDiagnosisMode`.
    pub fn set_diagnosis_mode(&mut self, mode: bool) -> Result<()> {
        call(|| unsafe { sys::dWorldSetDiagnosisMode(self.raw(), i32::from(mode)) })
    }

    /// List events as \*settings says from the next step on; settings 0, the default:
    /// none, at no cost. The list becomes empty; what overlaps a sensor then begins in the next step, what
    /// touches has begun already. Returns 1. Refused: settings smaller than \`kinds\` or larger than this
    /// library's; settings with bits that are no kind or values out of range; a call during a step; no memory
    /// for the list.
    ///
    /// C: `dWorldSetEventSettings`.
    pub fn set_event_settings(&mut self, settings: Option<&EventSettings>) -> Result<()> {
        let settings = settings.map(EventSettings::to_raw);
        call(|| unsafe { sys::dWorldSetEventSettings(self.raw(), settings.as_ref().map_or(std::ptr::null(), std::ptr::from_ref)); })
    }

    /// Switch the report of steps on (mode 1) or off (0, the default). A report
    /// costs one more evaluation of the residual per step. Other values are refused.
    ///
    /// C: `dWorldSetStepReportMode`.
    pub fn set_step_report_mode(&mut self, mode: bool) -> Result<()> {
        call(|| unsafe { sys::dWorldSetStepReportMode(self.raw(), i32::from(mode)) })
    }

    /// Let steps keep an account of energy. Returns 1.
    ///
    /// C: `dWorldSetEnergyLedgerMode`.
    pub fn set_energy_ledger_mode(&mut self, mode: bool) -> Result<()> {
        call(|| unsafe { sys::dWorldSetEnergyLedgerMode(self.raw(), i32::from(mode)); })
    }

    /// Set the largest number of threads of a step of this world, the caller's
    /// included; 1 is the default, 0 means one for each processor, at most 64. The bits do not depend on it.
    /// Callbacks run on the caller's thread, memory handlers on any.
    /// dWorldSetStepIslandsProcessingMaxThreadCount limits the number further; an implementation set by
    /// dWorldSetStepThreadingImplementation replaces these threads. Negative numbers are refused.
    ///
    /// C: `dWorldSetStepThreads`.
    pub fn set_step_threads(&mut self, threads: i32) -> Result<()> {
        call(|| unsafe { sys::dWorldSetStepThreads(self.raw(), threads) })
    }

    /// Set how much of the last step's constraint forces a step starts from:
    /// factor, 0 ... 1, of each stepper's usual share; default 1, 0 starts from nothing as ODE does. The
    /// answer of dWorldStep does not depend on it, only its time. Values outside 0 ... 1 are refused.
    ///
    /// C: `dWorldSetStepWarmStarting`.
    pub fn set_step_warm_starting(&mut self, factor: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetStepWarmStarting(self.raw(), factor) })
    }

    /// Choose how the friction of contact joints is bounded. mode 0 (the default): each
    /// direction by itself, as ODE does. mode 1: both together, \|(f1/l1, f2/l2)\| \<= 1 with the limits l1 and
    /// l2 of the two directions: with one mu Coulomb's cone. World-managed contacts (ode/contacts.h) always
    /// have the cone in dWorldStepFast1 and dWorldQuickStep; in dWorldStep they have mode 1, too, and in mode 0
    /// bounds along their sliding and across. In dWorldStep limits follow in mode 1 from the present normal forces,
    /// not from those without friction: ladders stand. Refused: other values, a call during a step.
    ///
    /// C: `dWorldSetFrictionCone`.
    pub fn set_friction_cone(&mut self, mode: bool) -> Result<()> {
        call(|| unsafe { sys::dWorldSetFrictionCone(self.raw(), i32::from(mode)) })
    }

    /// Choose whether dWorldQuickStep and dWorldStepFast1 bound friction point by
    /// point (mode 0, the default) or once for all points of a manifold (mode 1): a force at the centre of
    /// the normal forces and a torque about the normal, bounded together. Feedback and reports still have
    /// each point's part. Faster for world-managed contacts, slower for contact joints. Other values are
    /// refused, as is a call during a step.
    ///
    /// C: `dWorldSetManifoldFriction`.
    pub fn set_manifold_friction(&mut self, mode: bool) -> Result<()> {
        call(|| unsafe { sys::dWorldSetManifoldFriction(self.raw(), i32::from(mode)) })
    }

    /// Choose how bodies under joints and contacts rotate: as ODE rotates them (mode 0, the default) or exactly
    /// (mode 1, dDefaultsGame and dDefaultsRobot), by the exponential map with the gyroscopic torque of the implicit midpoint rule: a free
    /// body keeps its energy and angular momentum while it turns by less than 2 rad in a step, a top its precession. A wheel that turns far
    /// in a step does so about the axis of its hinge, hinge-2, piston, universal or PU joint, and then with what carries it. Bodies on nothing
    /// rotate exactly in both modes, but with dBehaviour016 in mode 1 only. Other values are refused, as is a call during a step.
    ///
    /// C: `dWorldSetExactRotation`.
    pub fn set_exact_rotation(&mut self, mode: bool) -> Result<()> {
        call(|| unsafe { sys::dWorldSetExactRotation(self.raw(), i32::from(mode)) })
    }

    /// Choose whether dWorldStep solves islands of robots in the coordinates of their joints (mode 1, dDefaultsRobot and
    /// dDefaultsGame) or of their bodies (mode 0, the default): joints stay closed, energy does not drift, rotation is exact, and a robot's step costs a
    /// fraction. So where most joints are hinges, sliders, balls and fixed ones that have no springs of their own and are closed to the tolerance of
    /// dWorldSetStepProjection (joints that close loops, and those of other types, are solved with them), bodies turn by less than 2 rad in a step, no
    /// kinematic body that moves holds a joint, and loads do not make light links swing faster than it follows; contacts, stops, motors and drives may
    /// act, but where dWorldStepHybrid limits the time of exact steps, no contacts, few bodies and few of the others. Other islands are solved as in mode 0:
    /// dIslandStepReport::method says how. Other values are refused, as is a call during a step.
    ///
    /// C: `dWorldSetJointCoordinates`.
    pub fn set_joint_coordinates(&mut self, mode: i32) -> Result<()> {
        call(|| unsafe { sys::dWorldSetJointCoordinates(self.raw(), mode) })
    }

    /// Set into how many equal substeps (count) dWorldStep divides its step; 1 is the
    /// default. Each is an exact solve with the poses, joints and stops of that moment, after one collision.
    /// ERP and CFM keep their meaning for the whole step, forces are held over it, and joint feedback is the
    /// mean. Errors fall as with as many steps; time grows with their number. Values outside 1 ... 1000 are
    /// refused.
    ///
    /// C: `dWorldSetExactSubsteps`.
    pub fn set_exact_substeps(&mut self, count: i32) -> Result<()> {
        call(|| unsafe { sys::dWorldSetExactSubsteps(self.raw(), count) })
    }

    /// Set how many Newton iterations on positions may follow each dWorldStep, 0
    /// (the default, as in ODE) to 100; 8 are plenty. They close joints until the worst error is below the
    /// tolerance, and push contacts apart by the share that is their ERP, without changing velocities.
    /// Springs, motors and friction are left alone. Costs about as much again as the step. Other values are
    /// refused.
    ///
    /// C: `dWorldSetStepProjection`.
    pub fn set_step_projection(&mut self, iterations: i32) -> Result<()> {
        call(|| unsafe { sys::dWorldSetStepProjection(self.raw(), iterations) })
    }

    /// Set the error (tolerance) that the projection need not remove: of
    /// angles in rad, of lengths as a share of the longest lever (from the centre of a body to the joint, at
    /// least its radius of gyration). Default 1e-4 (1e-3 in single precision). Values outside 0 ... 1, and
    /// both ends, are refused.
    ///
    /// C: `dWorldSetStepProjectionTolerance`.
    pub fn set_step_projection_tolerance(&mut self, tolerance: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetStepProjectionTolerance(self.raw(), tolerance) })
    }

    /// Set how hybrid steps solve islands none of whose bodies requests a stepper;
    /// dStepperHybrid, the default, lets the library choose. Other numbers are refused.
    ///
    /// C: `dWorldSetHybridStepper`.
    pub fn set_hybrid_stepper(&mut self, stepper: Stepper) -> Result<()> {
        call(|| unsafe { sys::dWorldSetHybridStepper(self.raw(), stepper.number()) })
    }

    /// Set how many substeps (count) a hybrid step has where it has any; default 4.
    /// Values outside 1 ... 10000 are refused.
    ///
    /// C: `dWorldSetHybridSubsteps`.
    pub fn set_hybrid_substeps(&mut self, count: i32) -> Result<()> {
        call(|| unsafe { sys::dWorldSetHybridSubsteps(self.raw(), count) })
    }

    /// Set how long the exact solutions of a hybrid step may take together, times what
    /// substeps of all its islands would (times); default 1. What does not fit takes substeps. The same on every
    /// machine: work is counted, not timed, and 0.5 ms times \`times\` are always allowed. Islands whose bodies
    /// request dStepperExact, and those with couplings, do not count. 0: nothing else is solved exactly;
    /// dInfinity: whatever the rules of docs/solvers.md choose. Values below 0 are refused.
    ///
    /// C: `dWorldSetHybridBudget`.
    pub fn set_hybrid_budget(&mut self, times: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetHybridBudget(self.raw(), times) })
    }

    /// Set gravity to (x, y, z), m/s^2, world frame; default (0, 0, 0). It acts on every
    /// body whose gravity mode is on.
    ///
    /// C: `dWorldSetGravity`; `xyz` is (x, y, z).
    pub fn set_gravity(&mut self, xyz: Vec3) -> Result<()> {
        call(|| unsafe { sys::dWorldSetGravity(self.raw(), xyz[0], xyz[1], xyz[2]) })
    }

    /// Set the world's error reduction parameter erp: the part of joint errors that is corrected
    /// per step, sensibly 0.1 ... 0.8, default 0.2. Joints use the current value, except those parameters that
    /// a joint copies when it is created (dParamERP, dParamStopERP, dParamSuspensionERP).
    ///
    /// C: `dWorldSetERP`.
    pub fn set_erp(&mut self, erp: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetERP(self.raw(), erp) })
    }

    /// Set the world's constraint force mixing cfm: the softness of joints, sensibly 1e-9 ... 1,
    /// default 1e-10 (1e-5 in single precision). Joints use the current value, except those parameters that a
    /// joint copies when it is created (dParamCFM, dParamStopCFM, dParamSuspensionCFM). The default has a limit
    /// under heavy bodies (docs/guide/softness.md); other numbers are literal. A negative one is refused.
    ///
    /// C: `dWorldSetCFM`.
    pub fn set_cfm(&mut self, cfm: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetCFM(self.raw(), cfm) })
    }

    /// Set the most threads (count) that work on a step; 0 (the
    /// default, dWORLDSTEP\_THREADCOUNT\_UNLIMITED) sets no limit. It is a limit only: a world that has been
    /// given no threads steps on the calling thread.
    ///
    /// C: `dWorldSetStepIslandsProcessingMaxThreadCount`.
    pub fn set_step_islands_processing_max_thread_count(&mut self, count: u32) -> Result<()> {
        call(|| unsafe { sys::dWorldSetStepIslandsProcessingMaxThreadCount(self.raw(), count) })
    }

    /// Give the blocks back at once, with what the world keeps to save time; settings stay, and no result
    /// changes. Concerns all worlds that share the memory.
    ///
    /// C: `dWorldCleanupWorkingMemory`.
    pub fn cleanup_working_memory(&mut self) -> Result<()> {
        call(|| unsafe { sys::dWorldCleanupWorkingMemory(self.raw()) })
    }

    /// Set how many iterations (num) dWorldQuickStep makes, default 20. 0 or
    /// less lets the joints exert no force. More than 100000 are refused.
    ///
    /// C: `dWorldSetQuickStepNumIterations`.
    pub fn set_quick_step_num_iterations(&mut self, num: i32) -> Result<()> {
        call(|| unsafe { sys::dWorldSetQuickStepNumIterations(self.raw(), num) })
    }

    /// Set the factor over\_relaxation of dWorldQuickStep, sensibly within (0, 2), default
    /// 1.3.
    ///
    /// C: `dWorldSetQuickStepW`.
    pub fn set_quick_step_w(&mut self, over_relaxation: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetQuickStepW(self.raw(), over_relaxation) })
    }

    /// Set the greatest velocity vel, m/s, that a contact may use to undo
    /// penetration, and, if finite, to move joints back from beyond stops; default dInfinity. Bouncing is free. If
    /// it is finite, a step that would throw an island by closing joints or contacts makes a share of that.
    ///
    /// C: `dWorldSetContactMaxCorrectingVel`.
    pub fn set_contact_max_correcting_vel(&mut self, vel: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetContactMaxCorrectingVel(self.raw(), vel) })
    }

    /// Set the depth of penetration, m, that contacts leave alone so that they
    /// persist; default 0.
    ///
    /// C: `dWorldSetContactSurfaceLayer`.
    pub fn set_contact_surface_layer(&mut self, depth: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetContactSurfaceLayer(self.raw(), depth) })
    }

    /// Set the linear speed linear\_average\_threshold, m/s, up to which
    /// new bodies count as idle; default 0.01.
    ///
    /// C: `dWorldSetAutoDisableLinearThreshold`.
    pub fn set_auto_disable_linear_threshold(&mut self, linear_average_threshold: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetAutoDisableLinearThreshold(self.raw(), linear_average_threshold) })
    }

    /// Set the angular speed angular\_average\_threshold, rad/s, up to
    /// which new bodies count as idle; default 0.01.
    ///
    /// C: `dWorldSetAutoDisableAngularThreshold`.
    pub fn set_auto_disable_angular_threshold(&mut self, angular_average_threshold: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetAutoDisableAngularThreshold(self.raw(), angular_average_threshold) })
    }

    /// Set over how many steps (average\_samples\_count) the velocities
    /// of new bodies are averaged, as vectors, so that swinging cancels. Default 1: the current velocity; 0:
    /// never disable. More than 2^20 are refused.
    ///
    /// C: `dWorldSetAutoDisableAverageSamplesCount`.
    pub fn set_auto_disable_average_samples_count(&mut self, average_samples_count: u32) -> Result<()> {
        call(|| unsafe { sys::dWorldSetAutoDisableAverageSamplesCount(self.raw(), average_samples_count) })
    }

    /// Set how many idle steps new bodies need before they are disabled; default
    /// 10.
    ///
    /// C: `dWorldSetAutoDisableSteps`.
    pub fn set_auto_disable_steps(&mut self, steps: i32) -> Result<()> {
        call(|| unsafe { sys::dWorldSetAutoDisableSteps(self.raw(), steps) })
    }

    /// Set how much idle time, s, new bodies need before they are disabled; default
    /// 0.
    ///
    /// C: `dWorldSetAutoDisableTime`.
    pub fn set_auto_disable_time(&mut self, time: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetAutoDisableTime(self.raw(), time) })
    }

    /// Set whether new bodies disable themselves (do\_auto\_disable not 0); default 0.
    ///
    /// C: `dWorldSetAutoDisableFlag`.
    pub fn set_auto_disable_flag(&mut self, do_auto_disable: bool) -> Result<()> {
        call(|| unsafe { sys::dWorldSetAutoDisableFlag(self.raw(), i32::from(do_auto_disable)) })
    }

    /// Set the linear speed threshold, m/s, from which on damping acts on new
    /// bodies; default 0.01.
    ///
    /// C: `dWorldSetLinearDampingThreshold`.
    pub fn set_linear_damping_threshold(&mut self, threshold: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetLinearDampingThreshold(self.raw(), threshold) })
    }

    /// Set the angular speed threshold, rad/s, from which on damping acts on
    /// new bodies; default 0.01.
    ///
    /// C: `dWorldSetAngularDampingThreshold`.
    pub fn set_angular_damping_threshold(&mut self, threshold: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetAngularDampingThreshold(self.raw(), threshold) })
    }

    /// Set the scale of linear damping of new bodies, sensibly 0 ... 1; default 0, no
    /// damping.
    ///
    /// C: `dWorldSetLinearDamping`.
    pub fn set_linear_damping(&mut self, scale: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetLinearDamping(self.raw(), scale) })
    }

    /// Set the scale of angular damping of new bodies, sensibly 0 ... 1; default 0,
    /// no damping.
    ///
    /// C: `dWorldSetAngularDamping`.
    pub fn set_angular_damping(&mut self, scale: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetAngularDamping(self.raw(), scale) })
    }

    /// Set the scales of linear (linear\_scale) and angular damping (angular\_scale) of new
    /// bodies, each sensibly 0 ... 1; default 0, no damping.
    ///
    /// C: `dWorldSetDamping`.
    pub fn set_damping(&mut self, linear_scale: Real, angular_scale: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetDamping(self.raw(), linear_scale, angular_scale) })
    }

    /// Set the angular speed max\_speed, rad/s, that new bodies are held to; default
    /// dInfinity.
    ///
    /// C: `dWorldSetMaxAngularSpeed`.
    pub fn set_max_angular_speed(&mut self, max_speed: Real) -> Result<()> {
        call(|| unsafe { sys::dWorldSetMaxAngularSpeed(self.raw(), max_speed) })
    }
}
