#pragma once

#include <QWidget>
#include <optional>

#include "app/report/legend_painter.h"

class QComboBox;

namespace noonmark {

/// Below the view: which measure is shown, its legend, and where north is.
class LegendStrip final : public QWidget {
    Q_OBJECT
public:
    explicit LegendStrip(QWidget* parent = nullptr);

    void setLegend(std::optional<Legend> legend);  ///< none: no study yet
    [[nodiscard]] const std::optional<Legend>& legend() const { return legend_; }
    void setHeading(double degrees);  ///< azimuth of the view, clockwise from north

    [[nodiscard]] ShadowMeasure measure() const;
    void setMeasure(ShadowMeasure measure);

Q_SIGNALS:
    void measureChanged();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QComboBox* measure_;
    std::optional<Legend> legend_;
    double headingDeg_ = 0;
};

}  // namespace noonmark
