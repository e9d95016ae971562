#pragma once

#include <QString>
#include <optional>

#include "core/base/display_units.h"

namespace noonmark {

/// A length that is typed over the view, "40", "131' 3\"" or "40 m", key by key; if wanted followed by an
/// azimuth, "40<30" or "40;30".
class TypedLength {
public:
    enum class Taken { no, changed, entered };
    enum class Form { length, lengthAndAzimuth };

    explicit TypedLength(Form form = Form::length) : form_(form) {}

    /// Takes a key of Qt::Key. Digits begin; Backspace removes the last character, Esc all; Enter makes it
    /// `entered`. Without a text only digits and the decimal point are taken.
    Taken take(int key);
    /// Whether take() would use the key although it may be a shortcut: only once something is typed, so that
    /// shortcuts stay.
    [[nodiscard]] bool claims(int key) const;

    [[nodiscard]] bool empty() const { return text_.isEmpty(); }
    [[nodiscard]] const QString& text() const { return text_; }
    QString finish();  ///< the text; nothing is typed from then on
    void clear() { text_.clear(); }
    /// The text for display: a number alone with the unit in use.
    [[nodiscard]] QString withUnit() const;

private:
    [[nodiscard]] bool canFollow(int key) const;

    Form form_;
    QString text_;
};

/// A side of an outline as it is typed.
struct TypedSide {
    double lengthM = 0;
    std::optional<double> azimuthDeg;  ///< clockwise from north; empty: towards the cursor
    bool operator==(const TypedSide&) const = default;
};

/// "40", "131' 3\"", "40 m<30", "40;30.5": a length as parseLength() takes it, and degrees after the mark.
/// Nothing for any other text, and for a length that is not positive.
std::optional<TypedSide> parseTypedSide(const QString& text, UnitSystem units);

}  // namespace noonmark
