#include "host/cli/common/fair_rounds.hpp"

namespace quell::cli {

CopyBandwidth measureCopy(const DenoiseSession& session) {
  return measureCopyBandwidth(session.context(), session.deviceId(), session.queue());
}

}  // namespace quell::cli
