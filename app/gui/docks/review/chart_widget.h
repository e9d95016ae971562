#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "app/report/maps/style.h"

namespace noonmark {

/// A widget that shows a chart of app/report/charts and reports where the mouse is on it.
class ChartWidget final : public QWidget {
    Q_OBJECT
public:
    using Paint = std::function<void(const Canvas&, const QRectF&)>;
    explicit ChartWidget(QWidget* parent = nullptr);

    void show(Paint paint);              ///< replaces the chart
    [[nodiscard]] QRectF area() const;   ///< in which the chart is painted
    [[nodiscard]] double point() const;  ///< as in Canvas

    [[nodiscard]] QSize sizeHint() const override { return {420, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 120}; }

Q_SIGNALS:
    void hovered(QPointF at);
    void left();
    void clicked(QPointF at);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    Paint paint_;
    std::optional<double> cursor_;  ///< the mouse's column, for the vertical line
};

}  // namespace noonmark
