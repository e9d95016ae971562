#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

/// The names that someone may have meant who wrote `text`: few letters away, or whose last part ("New_York")
/// is. Best first.
std::vector<std::string> findCloseNames(std::string_view text, const std::vector<std::string>& names,
                                        std::size_t most = 3);

}  // namespace noonmark
