#include "core/base/result.h"

namespace noonmark {

namespace {
constexpr std::string_view cancelledText = "Cancelled";

void appendSentence(std::string& text, const std::string& sentence) {
    if (sentence.empty()) return;
    if (!text.empty()) text += text.back() == '.' ? " " : ". ";
    text += sentence;
}
}  // namespace

std::string Error::text() const {
    std::string text = where.empty() ? what : where + ": " + what;
    appendSentence(text, advice);
    return text;
}

tl::unexpected<Error> failure(std::string what, std::string where, std::string advice) {
    return tl::make_unexpected(Error{std::move(what), std::move(where), std::move(advice)});
}

tl::unexpected<Error> cancelled() { return failure(std::string(cancelledText)); }

bool isCancelled(const Error& error) { return error.what == cancelledText; }

}  // namespace noonmark
