// `devices`: asks every driver that can be found, in a process that may die of it.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "harness/cli/isolated.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/run.hpp"
#include "harness/report/listing.hpp"

namespace rasterdiff::harness::cli {

int runVerb(const DevicesOptions& options) {
  constexpr double kSeconds = 60;
  const Result<std::string> listing = isolated(kSeconds, [&]() -> Result<std::string> {
    const std::vector<vkref::DriverCandidate> candidates = vkref::listDrivers();
    const bool usable = std::ranges::any_of(candidates, &vkref::DriverCandidate::usable);
    return (usable ? '1' : '0') + (options.json ? devicesJson(candidates) : devicesText(candidates));
  });
  if (!listing) return complain(listing.error(), "rasterdiff devices --help");
  fmt::print("{}", listing->substr(1));
  if (listing->front() == '1') return 0;
  std::fflush(stdout);
  return complain({ErrorCode::NoDevice, "devices", "no driver can be used", "Debian's package of lavapipe:"},
                  "apt-get install mesa-vulkan-drivers");
}

}  // namespace rasterdiff::harness::cli
