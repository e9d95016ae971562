#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "core/base/units.h"

namespace noonmark {

/// Takes keys from the window's shortcuts while the view has them: "m" of a length that is typed is no
/// shortcut then.
class ShortcutClaim final : public QObject {
public:
    /// `claims` is asked for keys of Qt::Key without Ctrl, Alt and Meta. `view` must outlive this object.
    ShortcutClaim(QObject& view, std::function<bool(int key)> claims);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<bool(int)> claims_;
};

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
