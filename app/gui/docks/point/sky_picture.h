#pragma once

#include <QImage>
#include <QSvgRenderer>
#include <QWidget>

namespace noonmark {

/// The drawing of a sky in a scroll area: so wide that the skyline, its upper part, is seen whole.
class SkyPicture final : public QWidget {
public:
    explicit SkyPicture(QWidget* parent = nullptr);

    void setDrawing(const QByteArray& svg);  ///< empty: nothing
    void fitInto(QSize room);                ///< the visible size
    /// The drawing as a picture of this width.
    [[nodiscard]] QImage image(int widthPx);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] int heightFor(int widthPx) const;

    QSvgRenderer renderer_;
    QSize room_{0, 0};
};

}  // namespace noonmark
