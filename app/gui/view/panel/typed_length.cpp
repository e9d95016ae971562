#include "app/gui/view/panel/typed_length.h"

#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/base/looks/units.h"

namespace noonmark {

ShortcutClaim::ShortcutClaim(QObject& view, std::function<bool(int)> claims) : claims_(std::move(claims)) {
    view.installEventFilter(this);
}

// Accepting the event that Qt sends before it looks for a shortcut makes the key an ordinary one.
bool ShortcutClaim::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(watched, event);
    const auto& key = static_cast<QKeyEvent&>(*event);
    const bool plain = !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (!plain || !claims_(key.key())) return QObject::eventFilter(watched, event);
    event->accept();
    return true;
}

namespace {

bool isDigit(int key) { return key >= Qt::Key_0 && key <= Qt::Key_9; }

bool isPoint(int key) { return key == Qt::Key_Period || key == Qt::Key_Comma; }

bool isEnter(int key) { return key == Qt::Key_Return || key == Qt::Key_Enter; }

bool isAngleMark(QChar c) { return c == QLatin1Char('<') || c == QLatin1Char(';'); }

qsizetype findAngleMark(const QString& text) {
    return std::ranges::find_if(text, isAngleMark) - text.begin();
}

}  // namespace

// Units and marks of feet, inches, metres, centimetres and millimetres; the mark of an angle only once.
bool TypedLength::canFollow(int key) const {
    if (key > 0xff) return false;
    const QChar c(key);
    if (QStringLiteral("'\"/ FTINCM").contains(c)) return true;
    return form_ == Form::lengthAndAzimuth && isAngleMark(c) && findAngleMark(text_) == text_.size();
}

TypedLength::Taken TypedLength::take(int key) {
    if (isDigit(key) || isPoint(key) || (!empty() && canFollow(key)))
        text_ += isPoint(key) ? QLatin1Char('.') : QChar(key).toLower();
    else if (empty())
        return Taken::no;
    else if (key == Qt::Key_Backspace)
        text_.chop(1);
    else if (key == Qt::Key_Escape)
        clear();
    else
        return isEnter(key) ? Taken::entered : Taken::no;
    return Taken::changed;
}

bool TypedLength::claims(int key) const {
    return !empty() && (isDigit(key) || isPoint(key) || canFollow(key) || isEnter(key) ||
                        key == Qt::Key_Backspace || key == Qt::Key_Escape);
}

QString TypedLength::finish() { return std::exchange(text_, {}); }

QString TypedLength::withUnit() const {
    const QString length = text_.left(findAngleMark(text_));
    const bool isNumber = !length.isEmpty() && std::ranges::none_of(length, [](QChar c) {
        return !c.isDigit() && c != QLatin1Char('.');
    });
    if (!isNumber) return text_;
    const QString unit = unitsInUse() == UnitSystem::imperial ? QStringLiteral(" ft") : QStringLiteral(" m");
    return length + unit + text_.mid(length.size());
}

std::optional<TypedSide> parseTypedSide(const QString& text, UnitSystem units) {
    const qsizetype mark = findAngleMark(text);
    const auto length = parseLength(text.left(mark).toStdString(), units);
    if (!length || *length <= 0) return std::nullopt;
    if (mark == text.size()) return TypedSide{*length, {}};
    bool isNumber = false;
    const double degrees = text.mid(mark + 1).toDouble(&isNumber);
    if (!isNumber || !std::isfinite(degrees)) return std::nullopt;
    return TypedSide{*length, degrees};
}

}  // namespace noonmark
