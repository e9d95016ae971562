#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace noonmark::bench {

/// Peak memory of the process while `work` runs, minus its memory before, bytes, as the system counts pages
/// (resident set; Linux). Memory that the process freed before is returned to the system first, so that it
/// does not hide what `work` takes. Nothing if the system does not provide these numbers. Memory of other
/// threads counts too.
std::optional<std::uint64_t> measurePeakMemory(const std::function<void()>& work);

}  // namespace noonmark::bench
