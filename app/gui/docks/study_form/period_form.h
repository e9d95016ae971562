#pragma once

#include <QWidget>

#include "app/gui/base/widgets/field_rows.h"
#include "core/sun/period_fields.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace noonmark {

/// Fields for a Period: dates, hours, time zone, apparent or geometric sun.
class PeriodForm final : public QWidget {
    Q_OBJECT
public:
    explicit PeriodForm(QWidget* parent = nullptr);

    [[nodiscard]] Period period() const;
    void show(const Period& period);  ///< without a signal

Q_SIGNALS:
    void edited(QString field);  ///< the name of the field: "start date"

private:
    void makeFields();
    void placeFields();
    void tell();
    void follow(QWidget* field, const char* name);
    void enableFields();

    FieldRows rows_{periodFields().rows()};  ///< all but those of the sun's hours
    QCheckBox* window_;
    QDoubleSpinBox* afterSunrise_;
    QDoubleSpinBox* beforeSunset_;
    QComboBox* rule_;
    bool showing_ = false;
};

}  // namespace noonmark
