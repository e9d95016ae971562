#include "core/base/result.h"

#include "core/base/safe_text.h"

namespace noonmark {

namespace {
void appendSentence(std::string& text, const std::string& sentence) {
    if (sentence.empty()) return;
    if (!text.empty()) text += text.back() == '.' ? " " : ". ";
    text += sentence;
}
}  // namespace

std::string Error::text() const {
    std::string text = where.empty() ? what : where + ": " + what;
    appendSentence(text, advice);
    return cleanText(text);
}

tl::unexpected<Error> failure(std::string what, std::string where, std::string advice) {
    return tl::make_unexpected(Error{std::move(what), std::move(where), std::move(advice), ErrorKind::input});
}

tl::unexpected<Error> unsupported(std::string what, std::string where, std::string advice) {
    return tl::make_unexpected(
        Error{std::move(what), std::move(where), std::move(advice), ErrorKind::unsupported});
}

tl::unexpected<Error> limitReached(std::string what, std::string where, std::string advice) {
    return tl::make_unexpected(Error{std::move(what), std::move(where), std::move(advice), ErrorKind::limit});
}

tl::unexpected<Error> internalError(std::string what, std::string where) {
    return tl::make_unexpected(
        Error{std::move(what), std::move(where), "This is a defect: please report it", ErrorKind::internal});
}

tl::unexpected<Error> cancelled() {
    return tl::make_unexpected(Error{"Cancelled", "", "", ErrorKind::cancelled});
}

}  // namespace noonmark
