#pragma once

#include <QString>
#include <string>
#include <string_view>

namespace noonmark {

// Names that the program gives, in the language of the window; those of users stay as they are.

/// A scenario; the existing city is one, too.
QString scenarioName(const std::string& name);

/// A weight table or an interval of one: "default", "January".
QString weightName(const std::string& name);

/// A text of a rule file: its name, place, summary, a criterion, an option...; or its country.
QString ruleName(std::string_view name);

struct Contribution;
/// A tree in lists: "Tree Tilia cordata (node/123)".
QString nameOfTree(const Contribution& tree);

/// Rich text that emits QLabel::linkActivated(target).
QString makeLink(const QString& target, const QString& text);

}  // namespace noonmark
