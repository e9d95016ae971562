#pragma once

#include <set>
#include <string>
#include <string_view>

namespace noonmark {

/// Gives names that DXF takes and that differ whatever the case of their letters: letters, digits, hyphens,
/// points and underscores of ASCII, 1 to 200 of them; anything else becomes an underscore. "Größe: 1" is
/// "Gr__e__1", and a second one "Gr__e__1_2".
class LayerNames {
public:
    std::string add(std::string_view wanted);

private:
    std::set<std::string> taken_;  // in lower case
};

}  // namespace noonmark
