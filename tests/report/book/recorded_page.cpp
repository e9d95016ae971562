#include "tests/report/book/recorded_page.h"

#include <QPainter>
#include <algorithm>

namespace noonmark::tests {

class RecordedPage::Recorder final : public QPaintEngine {
public:
    Recorder() : QPaintEngine(AllFeatures) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {}
    void drawPath(const QPainterPath&) override {}
    void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
    [[nodiscard]] Type type() const override { return User; }

    /// Letters fill less of a line than it is high; texts that follow each other touch.
    static QRectF inkOf(const QRectF& line) {
        const double side = std::min(line.width() / 4, line.height() / 10);
        return line.adjusted(side, line.height() * 0.25, -side, -line.height() * 0.2);
    }

    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        const QTransform transform = painter()->transform();
        const QRectF box(at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent());
        const bool isClipped =
            painter()->hasClipping() && !painter()->clipBoundingRect().contains(box.adjusted(1, 1, -1, -1));
        texts_.push_back(
            {item.text(), transform.mapRect(box), transform.map(QPolygonF(inkOf(box))), isClipped});
    }

    std::vector<PaintedText> texts_;
};

RecordedPage::RecordedPage(QSize size) : size_(size), recorder_(std::make_unique<Recorder>()) {}
RecordedPage::~RecordedPage() = default;

const std::vector<PaintedText>& RecordedPage::texts() const { return recorder_->texts_; }

QString RecordedPage::allText() const {
    QString all;
    for (const PaintedText& text : texts()) all += text.text + u' ';
    return all;
}

QPaintEngine* RecordedPage::paintEngine() const { return recorder_.get(); }

int RecordedPage::metric(PaintDeviceMetric metric) const {
    constexpr int dotsPerInch = 1200;
    switch (metric) {
        case PdmWidth:
            return size_.width();
        case PdmHeight:
            return size_.height();
        case PdmWidthMM:
            return size_.width() * 254 / dotsPerInch / 10;
        case PdmHeightMM:
            return size_.height() * 254 / dotsPerInch / 10;
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return dotsPerInch;
        case PdmDepth:
            return 32;
        default:
            return QPaintDevice::metric(metric);
    }
}

}  // namespace noonmark::tests
