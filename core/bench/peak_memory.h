#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace noonmark::bench {

/// How much more memory the process held at its peak while `work` ran than before it, bytes, as the system
/// counts pages (resident set; Linux). What the process had freed before is given back first, so that it does
/// not hide what `work` takes. Nothing where the system does not say. Other threads' memory counts too.
std::optional<std::uint64_t> measurePeakMemory(const std::function<void()>& work);

}  // namespace noonmark::bench
