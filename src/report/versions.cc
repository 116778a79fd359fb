#include <boost/version.hpp>

#include "report/report.h"
#include "solver/descent.h"

namespace mixity {

std::vector<std::pair<std::string, std::string>> versions() {
  const auto boost = std::to_string(BOOST_VERSION / 100000) + "." + std::to_string(BOOST_VERSION / 100 % 1000);
  return {{"mixity", MIXITY_VERSION},
          {"Ceres", std::string(solver_version())},
          {"Boost", boost},
          {"compiler", __VERSION__}};
}

}  // namespace mixity
