#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/receivers/place.h"

namespace noonmark {

/// For each place without a name of its own the place with a name that holds most of it or, if none does, the
/// one that lies along more than a fifth of its outline, as its index; none: there is none, or it has a
/// name. Streets and facades hold nothing and are part of nothing. Incomplete after a stop request. O(n log n
/// + pairs that meet).
std::vector<std::optional<std::size_t>> findWholes(const std::vector<Place>& places,
                                                   const std::stop_token& stop = {});

}  // namespace noonmark
