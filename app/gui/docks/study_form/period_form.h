#pragma once

#include <QWidget>

#include "app/gui/base/widgets/field_rows.h"
#include "core/sun/period_fields.h"

class QCheckBox;

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
    void placeFields();
    void tell();
    void enableFields();

    FieldRows rows_{periodFields().rows()};
    FieldRows solar_{solarHoursFields().rows()};  ///< of the hours from sunrise to sunset
    QCheckBox* window_;
    bool showing_ = false;
};

}  // namespace noonmark
