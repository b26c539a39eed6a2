#include "fe/shell.h"

#include <cassert>

namespace fe {

ShellRigidity scaled(ShellRigidity r, double share) { return scaled_rigidity(r, share); }

ShellRigidity tube_rigidity(double inner, double outer, double reference, double modulus,
                            double poisson, double shear_modulus) {
  assert(0.0 < inner && inner < outer);
  return tube_rigidity_of(inner, outer, reference, modulus, poisson, shear_modulus);
}

ShellMatrix to_matrix(const ShellBlocks<double>& k) {
  ShellMatrix m;
  // clang-format off
  m << k.uu, 0.0,  k.ut, k.uv, 0.0,
       0.0,  k.dd, 0.0,  0.0,  k.dm,
       k.ut, 0.0,  k.tt, k.tv, 0.0,
       k.uv, 0.0,  k.tv, k.vv, 0.0,
       0.0,  k.dm, 0.0,  0.0,  k.mm;
  // clang-format on
  return m;
}

ShellBlocks<double> to_blocks(const ShellMatrix& m) {
  return {m(0, 0), m(0, 2), m(0, 3), m(2, 2), m(2, 3), m(3, 3), m(1, 1), m(1, 4), m(4, 4)};
}

ShellMatrix stiffness_matrix(const ShellRigidity& shell, double length) {
  return to_matrix(shell_blocks(shell, length));
}

ShellMatrix about(const ShellMatrix& stiffness, double shift) {
  ShellMatrix t = ShellMatrix::Identity();
  t(0, 2) = shift;  // u at r_0 is u at r_0 + shift and theta times the shift
  return t.transpose() * stiffness * t;
}

}  // namespace fe
