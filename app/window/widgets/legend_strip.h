#pragma once

#include <QWidget>
#include <optional>

#include "app/report/maps/change_scale.h"
#include "app/report/maps/legend_painter.h"

class QComboBox;
class QPainter;
class QSpinBox;

namespace noonmark {

/// Below the view: which measure is shown, its legend, and where north is. Where it is narrow the legend has
/// a row of its own.
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

    /// Of differences; its field is in sight while one is shown.
    [[nodiscard]] const ChangeScale& changeScale() const { return changeScale_; }
    void setChangeScale(const ChangeScale& scale);

    [[nodiscard]] QRectF noteArea() const;      ///< where the note is painted; empty: there is none
    [[nodiscard]] QRectF legendArea() const;    ///< beside it
    [[nodiscard]] QString paintedNote() const;  ///< as much of the note as there is room for

Q_SIGNALS:
    void measureChanged();
    void changeScaleChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] bool narrow() const;
    [[nodiscard]] QFont noteFont() const;
    [[nodiscard]] QSizeF noteRoom() const;
    void placeNote();
    void paintNote(QPainter& painter) const;

    QComboBox* measure_;
    QSpinBox* scale_;  ///< 0: fitted to each difference
    ChangeScale changeScale_;
    QString hint_;
    QString note_;
    bool partial_ = false;
    std::optional<Legend> legend_;
    double headingDeg_ = 0;
};

}  // namespace noonmark
