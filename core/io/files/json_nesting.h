#pragma once

#include <string_view>

namespace noonmark {

/// Follows how deep JSON is nested while its bytes pass by: a parser takes some 60 bytes of memory for each
/// level, so that a file of nothing but brackets needs far more than its size.
class JsonNesting {
public:
    static constexpr int maxLevels = 500;

    /// False from the byte on that opens a level too many.
    [[nodiscard]] bool take(std::string_view bytes) {
        for (const char c : bytes) take(c);
        return levels_ <= maxLevels;
    }

private:
    void take(char c) {
        if (levels_ > maxLevels) return;
        if (inText_) {
            inText_ = isEscaped_ || c != '"';
            isEscaped_ = !isEscaped_ && c == '\\';
            return;
        }
        if (c == '"') inText_ = true;
        if (c == '[' || c == '{') ++levels_;
        if (c == ']' || c == '}') --levels_;
    }

    int levels_ = 0;
    bool inText_ = false, isEscaped_ = false;
};

}  // namespace noonmark
