// Times of Pinocchio's forward dynamics and of its derivatives. The tree of a robot and a state are
// read from standard input; nanoseconds, accelerations and their derivatives go to standard output.
#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/aba-derivatives.hpp>

#include <chrono>
#include <iostream>

using namespace pinocchio;
using Clock = std::chrono::steady_clock;

static Eigen::Vector3d vector() {
  Eigen::Vector3d v;
  std::cin >> v[0] >> v[1] >> v[2];
  return v;
}

static Eigen::Matrix3d matrix() {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; i++) m.row(i) = vector();
  return m;
}

static JointModel joint(const std::string& kind, const Eigen::Vector3d& axis) {
  if (kind == "JointModelRX") return JointModelRX();
  if (kind == "JointModelRY") return JointModelRY();
  if (kind == "JointModelRZ") return JointModelRZ();
  if (kind == "JointModelPX") return JointModelPX();
  if (kind == "JointModelPY") return JointModelPY();
  if (kind == "JointModelPZ") return JointModelPZ();
  if (kind == "JointModelPrismaticUnaligned") return JointModelPrismaticUnaligned(axis);
  return JointModelRevoluteUnaligned(axis);
}

// Least time of a call in nanoseconds, over rounds of many calls.
template <class Call>
static double nanoseconds(Call call) {
  double least = 1e300;
  for (int round = 0; round < 9; round++) {
    const int count = 10000;
    auto begin = Clock::now();
    for (int i = 0; i < count; i++) call();
    std::chrono::duration<double, std::nano> spent = Clock::now() - begin;
    least = std::min(least, spent.count() / count);
  }
  return least;
}

int main() {
  int count;
  Model model;
  std::cin >> count;
  model.gravity.linear() = vector();
  for (int n = 0; n < count; n++) {
    std::string kind;
    std::size_t parent;
    double mass;
    std::cin >> kind >> parent;
    Eigen::Vector3d axis = vector(), place = vector();
    Eigen::Matrix3d turned = matrix();
    std::cin >> mass;
    Eigen::Vector3d centre = vector();
    Inertia inertia(mass, centre, matrix());
    auto id = model.addJoint(parent, joint(kind, axis), SE3(turned, place), std::to_string(n));
    model.appendBodyToJoint(id, inertia, SE3::Identity());
  }
  Data data(model);
  Eigen::VectorXd q(model.nq), v(model.nv), tau(model.nv);
  for (auto* values : {&q, &v, &tau})
    for (int i = 0; i < count; i++) std::cin >> (*values)[i];
  if (!std::cin) return 1;
  const Eigen::VectorXd start = q;
  double rate = nanoseconds([&] {
    q[0] += 1e-9;
    aba(model, data, q, v, tau, Convention::LOCAL);
  });
  double jacobian = nanoseconds([&] {
    q[0] += 1e-9;
    computeABADerivatives(model, data, q, v, tau);
  });
  computeABADerivatives(model, data, start, v, tau);
  std::cout.precision(17);
  std::cout << rate << ' ' << jacobian << '\n' << data.ddq.transpose() << '\n';
  std::cout << data.ddq_dq << '\n' << data.ddq_dv << '\n';
}
