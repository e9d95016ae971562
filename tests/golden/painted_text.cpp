#include "tests/golden/painted_text.h"

#include <QPaintDevice>
#include <QPaintEngine>
#include <QWidget>

namespace noonmark::golden {

namespace {

/// Takes down the text and leaves out the rest.
class TextEngine final : public QPaintEngine {
public:
    TextEngine() : QPaintEngine(AllFeatures) {}
    [[nodiscard]] const QStringList& texts() const { return texts_; }

    bool begin(QPaintDevice* /*device*/) override { return true; }
    bool end() override { return true; }
    [[nodiscard]] Type type() const override { return User; }
    void updateState(const QPaintEngineState& /*state*/) override {}
    void drawTextItem(const QPointF& /*at*/, const QTextItem& item) override { texts_ << item.text(); }
    void drawRects(const QRect* /*rects*/, int /*count*/) override {}
    void drawRects(const QRectF* /*rects*/, int /*count*/) override {}
    void drawLines(const QLine* /*lines*/, int /*count*/) override {}
    void drawLines(const QLineF* /*lines*/, int /*count*/) override {}
    void drawEllipse(const QRect& /*rect*/) override {}
    void drawEllipse(const QRectF& /*rect*/) override {}
    void drawPath(const QPainterPath& /*path*/) override {}
    void drawPoints(const QPoint* /*points*/, int /*count*/) override {}
    void drawPoints(const QPointF* /*points*/, int /*count*/) override {}
    void drawPolygon(const QPoint* /*points*/, int /*count*/, PolygonDrawMode /*mode*/) override {}
    void drawPolygon(const QPointF* /*points*/, int /*count*/, PolygonDrawMode /*mode*/) override {}
    void drawPixmap(const QRectF& /*to*/, const QPixmap& /*pixmap*/, const QRectF& /*from*/) override {}
    void drawTiledPixmap(const QRectF& /*to*/, const QPixmap& /*pixmap*/, const QPointF& /*from*/) override {}
    void drawImage(const QRectF& /*to*/, const QImage& /*image*/, const QRectF& /*from*/,
                   Qt::ImageConversionFlags /*flags*/) override {}

private:
    QStringList texts_;
};

/// A device of the widget's size.
class TextDevice final : public QPaintDevice {
public:
    explicit TextDevice(const QWidget& like) : like_(like) {}
    [[nodiscard]] QPaintEngine* paintEngine() const override { return &engine_; }
    [[nodiscard]] const QStringList& texts() const { return engine_.texts(); }

protected:
    [[nodiscard]] int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
            case PdmWidth:
                return like_.width();
            case PdmHeight:
                return like_.height();
            case PdmWidthMM:
                return like_.widthMM();
            case PdmHeightMM:
                return like_.heightMM();
            case PdmDpiX:
            case PdmPhysicalDpiX:
                return like_.logicalDpiX();
            case PdmDpiY:
            case PdmPhysicalDpiY:
                return like_.logicalDpiY();
            case PdmDepth:
                return 32;
            case PdmNumColors:
                return 1 << 24;
            case PdmDevicePixelRatio:
                return 1;
            case PdmDevicePixelRatioScaled:
                return int(devicePixelRatioFScale());
            default:
                return QPaintDevice::metric(metric);
        }
    }

private:
    const QWidget& like_;
    mutable TextEngine engine_;
};

}  // namespace

QStringList paintedText(QWidget& widget) {
    TextDevice device(widget);
    widget.render(&device, {}, {}, QWidget::RenderFlags());
    return device.texts();
}

}  // namespace noonmark::golden
