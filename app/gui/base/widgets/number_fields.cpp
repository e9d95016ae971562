#include "app/gui/base/widgets/number_fields.h"

#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>

#include "app/gui/base/looks/units.h"
#include "core/base/units.h"

namespace noonmark {

QDoubleSpinBox* numberField(double low, double high, int decimals, double step, const QString& unit) {
    auto* field = new QDoubleSpinBox;
    field->setDecimals(decimals);
    field->setRange(low, high);
    field->setSingleStep(step);
    field->setSuffix(unit);
    field->setKeyboardTracking(false);
    return field;
}

QSpinBox* wholeField(int low, int high, const QString& unit) {
    auto* field = new QSpinBox;
    field->setRange(low, high);
    field->setSuffix(unit);
    field->setKeyboardTracking(false);
    return field;
}

namespace {

constexpr int imperialDecimals = 4;  // of metres: finer than the hundredth of an inch that is shown
constexpr double minFootStepM = 0.3;

bool showsFeet() { return unitsInUse() == UnitSystem::imperial; }

// A separator before three digits groups thousands, as the language writes them; any other is a decimal
// point.
std::optional<double> parsed(QString text, const QLocale& locale) {
    const QString group = QRegularExpression::escape(QString(locale.groupSeparator()));
    if (locale.decimalPoint() != locale.groupSeparator())
        text.remove(QRegularExpression(QStringLiteral("(?<=\\d)%1(?=\\d{3}(\\D|$))").arg(group)));
    return parseLength(text.toStdString(), unitsInUse());
}

}  // namespace

QString LengthField::textFromValue(double value) const {
    const double metres = value + zeroM_;
    if (showsFeet()) return QString::fromStdString(formatFeetAndInches(metres));
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    return tr("%1 m").arg(plain.toString(metres, 'f', decimals()));
}

bool LengthField::isNone(const QString& text) const {
    return !specialValueText().isEmpty() && text == specialValueText();
}

// A text that was not changed means the value itself, which the text may round.
double LengthField::valueFromText(const QString& text) const {
    if (isNone(text)) return minimum();
    if (text == textFromValue(value())) return value();
    const auto length = parsed(text, locale());
    return length ? *length - zeroM_ : value();
}

QValidator::State LengthField::validate(QString& text, int& /*position*/) const {
    if (isNone(text) || text == textFromValue(value())) return QValidator::Acceptable;
    const auto length = parsed(text, locale());
    const bool allowed =
        length && *length - zeroM_ >= minimum() - 1e-9 && *length - zeroM_ <= maximum() + 1e-9;
    return allowed ? QValidator::Acceptable : QValidator::Intermediate;
}

// What is out of range becomes the nearest possible length, what is no length the one before.
void LengthField::fixup(QString& text) const {
    if (text.trimmed().isEmpty() && !specialValueText().isEmpty()) return void(text = specialValueText());
    const auto length = parsed(text, locale());
    text = textFromValue(length ? std::clamp(*length - zeroM_, minimum(), maximum()) : value());
}

void LengthField::setZero(double zeroM) {
    if (zeroM == zeroM_) return;
    const double before = value();  // of the text as it is now
    zeroM_ = zeroM;
    const QSignalBlocker block(lineEdit());
    lineEdit()->setText(textFromValue(before));
}

LengthField* lengthField(double lowM, double highM, int decimals, double stepM) {
    auto* field = new LengthField;
    const double footStepM = stepM < minFootStepM ? metresPerFoot / 12 : metresPerFoot;
    field->setDecimals(showsFeet() ? imperialDecimals : decimals);
    field->setRange(lowM, highM);
    field->setSingleStep(showsFeet() ? footStepM : stepM);
    field->setKeyboardTracking(false);
    return field;
}

}  // namespace noonmark
