#include "core/base/xml_text.h"

namespace noonmark {

std::string escapeXml(std::string_view text) {
    std::string safe;
    for (const char letter : text) {
        if (letter == '<')
            safe += "&lt;";
        else if (letter == '>')
            safe += "&gt;";
        else if (letter == '&')
            safe += "&amp;";
        else if (letter == '"')
            safe += "&quot;";
        else
            safe += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
    }
    return safe;
}

}  // namespace noonmark
