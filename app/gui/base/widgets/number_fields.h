#pragma once

#include <QDoubleSpinBox>
#include <QString>

class QDoubleSpinBox;
class QSpinBox;

namespace noonmark {

/// A number field with a unit; emits a change only after the whole number was typed.
QDoubleSpinBox* numberField(double low, double high, int decimals, double step, const QString& unit);
QSpinBox* wholeField(int low, int high, const QString& unit);

/// A field for a length. Its value is in metres; it shows and takes the units in use (looks/units.h): feet
/// and inches where they are imperial, else metres. Any length may be typed with its unit: "12' 6\"", "3.5 m"
/// (core/base/units.h).
class LengthField final : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit LengthField(QWidget* parent = nullptr) : QDoubleSpinBox(parent) {}

    [[nodiscard]] QString textFromValue(double metres) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;

    /// Shows and takes lengths counted from another zero: what is shown is the value plus `zeroM`, metres.
    /// The value and its range stay.
    void setZero(double zeroM);

private:
    [[nodiscard]] bool isNone(const QString& text) const;

    double zeroM_ = 0;
};

/// Emits a change only after the whole length was typed. `low`, `high`: metres; `decimals`: of metres; a step
/// is a foot or, below 0.3 m, an inch in imperial units.
LengthField* lengthField(double lowM, double highM, int decimals, double stepM);

}  // namespace noonmark
