#include "host/check/checks.hpp"

#include <initializer_list>

namespace quell::check {

Result checkFrame(const Frame& now, const Frame* before) {
  const bool follows = before != nullptr && now.number == before->number + 1 &&
                       before->width() == now.width() && before->height() == now.height();
  const Context context(now, follows ? before : nullptr);
  Result result;
  for (const Group& group : {surfaceChecks(), cameraChecks(), depthChecks(), normalChecks(), motionChecks(),
                             historyChecks(), radianceChecks(), albedoChecks(), absentChecks()})
    for (const Check check : group) check(context, result);
  return result;
}

}  // namespace quell::check
