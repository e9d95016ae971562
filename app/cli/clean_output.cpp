#include "app/cli/clean_output.h"

#include "core/base/clean_text.h"

namespace noonmark::cli {

CleanOutput::~CleanOutput() { CleanOutput::sync(); }

CleanOutput::int_type CleanOutput::overflow(int_type letter) {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    const char one = traits_type::to_char_type(letter);
    return xsputn(&one, 1) == 1 ? letter : traits_type::eof();
}

std::streamsize CleanOutput::xsputn(const char* text, std::streamsize size) {
    waiting_.append(text, std::size_t(size));
    const auto lines = std::string_view(text, std::size_t(size)).rfind('\n');
    if (lines == std::string_view::npos) return size;
    return pass(waiting_.size() - (std::size_t(size) - lines - 1)) ? size : 0;
}

int CleanOutput::sync() { return pass(waiting_.size()) && out_.flush() ? 0 : -1; }

bool CleanOutput::pass(std::size_t size) {
    out_ << cleanLines(std::string_view(waiting_).substr(0, size));
    waiting_.erase(0, size);
    return bool(out_);
}

}  // namespace noonmark::cli
