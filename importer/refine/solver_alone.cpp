// SPDX-License-Identifier: GPL-3.0-or-later
// CHOLMOD's archive names two functions of METIS, which has no archive. They order sparse matrices for Ceres' sparse solvers;
// the problems here are dense (docs/develop/decisions/0206-axes-from-whole-lines.md). Each answers "not possible": -4 is METIS_ERROR.

extern "C" {
int METIS_NodeND(void*, void*, void*, void*, void*, void*, void*) { return -4; }
int METIS_ComputeVertexSeparator(void*, void*, void*, void*, void*, void*, void*) { return -4; }
}
