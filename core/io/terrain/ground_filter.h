#pragma once

#include <stop_token>
#include <vector>

#include "core/city/terrain/terrain.h"

namespace noonmark {

/// Which posts of a surface model do not show the ground: the `covered` ones (by outlines of buildings), and
/// those of trees and the like, found by a progressive morphological filter (Zhang and others, 2003: openings
/// by windows that grow to 40 m; what they take away is no ground if it is higher than 0.5 m plus 0.3 of the
/// window's growth, at most 3 m). A ridge narrower than the window may count as raised. O(posts) for each
/// window, on all cores. Ends early when stopped.
std::vector<char> findRaisedPosts(const Terrain& surface, const std::vector<char>& covered,
                                  const std::stop_token& stop = {});

}  // namespace noonmark
