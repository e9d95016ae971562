#include "app/gui/base/looks/icons.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

namespace noonmark {

namespace {

/// Draws an SVG whose lines are in `currentColor`, as web pages do.
class PaletteIcon final : public QIconEngine {
public:
    explicit PaletteIcon(QByteArray svg) : svg_(std::move(svg)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State /*state*/) override {
        QSvgRenderer(inColours(mode)).render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return picture;
    }

    QIconEngine* clone() const override { return new PaletteIcon(svg_); }

private:
    [[nodiscard]] QByteArray inColours(QIcon::Mode mode) const {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::WindowText;
        QByteArray svg = svg_;
        return svg.replace("currentColor", QApplication::palette().color(group, role).name().toLatin1());
    }

    QByteArray svg_;
};

}  // namespace

QIcon makeIcon(const QString& name) {
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QIcon(new PaletteIcon(file.readAll()));
}

}  // namespace noonmark
