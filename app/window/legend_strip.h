#pragma once

#include <QWidget>
#include <optional>

#include "app/report/legend_painter.h"

class QComboBox;
class QPainter;

namespace noonmark {

/// Below the view: which measure is shown, its legend, and where north is.
class LegendStrip final : public QWidget {
    Q_OBJECT
public:
    explicit LegendStrip(QWidget* parent = nullptr);

    void setLegend(std::optional<Legend> legend);  ///< none: nothing is shown yet
    void setHint(const QString& hint);             ///< stands in the place of a legend where there is none
    /// What is shown of the whole, in words; `partial` marks it as not the whole yet. Empty: all of it.
    void setNote(const QString& note, bool partial);
    [[nodiscard]] const QString& note() const { return note_; }
    [[nodiscard]] const std::optional<Legend>& legend() const { return legend_; }
    void setHeading(double degrees);  ///< azimuth of the view, clockwise from north

    [[nodiscard]] ShadowMeasure measure() const;
    void setMeasure(ShadowMeasure measure);

Q_SIGNALS:
    void measureChanged();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double paintNote(QPainter& painter) const;

    QComboBox* measure_;
    QString hint_;
    QString note_;
    bool partial_ = false;
    std::optional<Legend> legend_;
    double headingDeg_ = 0;
};

}  // namespace noonmark
