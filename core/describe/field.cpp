#include "core/describe/field.h"

#include <fmt/format.h>

#include <charconv>

namespace noonmark {

double fields::writtenAs(float number) {
    const std::string text = fmt::to_string(number);
    double written = number;
    std::from_chars(text.data(), text.data() + text.size(), written);
    return written;
}

std::string_view nameOf(const FieldFacts& facts) {
    return facts.flag.starts_with("--") ? facts.flag.substr(2) : facts.key;
}

void copyFields(const Described& from, const Editable& to, const std::set<std::string, std::less<>>& flags) {
    for (const Field& field : from.fields)
        if (flags.contains(field.flag)) (void)to.set(field, from.get(field));  // it came from such an object
}

tl::unexpected<Error> refuseValue(const FieldFacts& facts) {
    return failure(fmt::format("This is no value of '{}'", nameOf(facts)), std::string(nameOf(facts)),
                   std::string(facts.help));
}

}  // namespace noonmark
