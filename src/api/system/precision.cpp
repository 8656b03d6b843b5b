// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The library's side of the agreement on precision (ode/odeconfig.h). libode_single defines one name, which
// programs compiled for float refer to, and asks for another, which they define. The second is an entry in
// the dynamic symbol table without any relocation: static linkers report it when a program does not bring it,
// the dynamic one never looks it up, so that the library can also be opened by dlopen from programs in other
// languages. Rejected: versions on the symbols (Debian's library has none, and references without a version
// would still be bound), and a check in dInitODE (many programs never call it, and it is too late to refuse).
#include "ode/odeconfig.h"

#if defined(dSINGLE) && defined(__ELF__)
extern "C" const char dSinglePrecisionProgram_LinkWith_ode_single = 1;
__asm__(".globl dDoublePrecisionProgram_CompileWith_dIDESINGLE");
#endif
