#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <memory>
#include <vector>

namespace noonmark::tests {

/// A text as it was painted, in units of the device.
struct PaintedText {
    QString text;
    QRectF box;
    QPolygonF outline;       ///< the box of a turned text is larger than the text
    bool isClipped = false;  ///< a clip that does not hold all of the box was set
};

/// A paint device that records texts instead of painting them.
class RecordedPage final : public QPaintDevice {
public:
    explicit RecordedPage(QSize size);
    ~RecordedPage() override;
    [[nodiscard]] const std::vector<PaintedText>& texts() const;
    [[nodiscard]] QString allText() const;  ///< with a space after each piece
    [[nodiscard]] QPaintEngine* paintEngine() const override;

protected:
    int metric(PaintDeviceMetric metric) const override;

private:
    class Recorder;
    QSize size_;
    std::unique_ptr<Recorder> recorder_;
};

}  // namespace noonmark::tests
