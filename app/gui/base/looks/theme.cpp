#include "app/gui/base/looks/theme.h"

#include <QApplication>
#include <QEvent>
#include <QFile>
#include <QIconEngine>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QSettings>
#include <QSvgRenderer>
#include <utility>

namespace noonmark {

namespace {

const QString themeKey = QStringLiteral("theme");

struct PaletteColours {
    QColor window, base, text, quiet, disabled, highlight, highlightedText, link;
};

constexpr PaletteColours lightColours{{0xf6, 0xf7, 0xf8}, {0xff, 0xff, 0xff}, {0x1d, 0x20, 0x27},
                                      {0x5c, 0x61, 0x6b}, {0x9a, 0x9e, 0xa6}, {0x2f, 0x5f, 0x9e},
                                      {0xff, 0xff, 0xff}, {0x1f, 0x5c, 0xb0}};
constexpr PaletteColours darkColours{{0x2b, 0x2e, 0x34}, {0x22, 0x24, 0x29}, {0xe6, 0xe8, 0xeb},
                                     {0xa4, 0xaa, 0xb3}, {0x7d, 0x83, 0x8c}, {0x3d, 0x74, 0xb8},
                                     {0xff, 0xff, 0xff}, {0x8a, 0xb8, 0xf0}};

/// Calls a function when the theme of the application is another one.
class ThemeFollower final : public QObject {
public:
    ThemeFollower(QWidget& widget, std::function<void()> look)
        : QObject(&widget), look_(std::move(look)), shown_(themeInUse()) {
        widget.installEventFilter(this);
    }

    bool eventFilter(QObject*, QEvent* event) override {
        const bool palette =
            event->type() == QEvent::PaletteChange || event->type() == QEvent::ApplicationPaletteChange;
        // A look changes the widget's own palette, which comes here again.
        if (palette && std::exchange(shown_, themeInUse()) != themeInUse()) look_();
        return false;
    }

private:
    std::function<void()> look_;
    Theme shown_;
};

}  // namespace

Theme themeOf(const QPalette& palette) {
    const auto lightness = [&](QPalette::ColorRole role) { return palette.color(role).lightness(); };
    return lightness(QPalette::WindowText) > lightness(QPalette::Window) ? Theme::dark : Theme::light;
}

Theme themeInUse() { return themeOf(QApplication::palette()); }

QPalette makePalette(Theme theme) {
    const PaletteColours& colours = theme == Theme::dark ? darkColours : lightColours;
    QPalette palette(colours.window);  // shades of buttons and frames follow from it
    palette.setColor(QPalette::Base, colours.base);
    palette.setColor(QPalette::AlternateBase, colours.window);
    for (const auto role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText})
        palette.setColor(role, colours.text);
    palette.setColor(QPalette::Highlight, colours.highlight);
    palette.setColor(QPalette::HighlightedText, colours.highlightedText);
    palette.setColor(QPalette::PlaceholderText, colours.quiet);
    palette.setColor(QPalette::Link, colours.link);
    palette.setColor(QPalette::ToolTipBase, colours.base);
    palette.setColor(QPalette::ToolTipText, colours.text);
    for (const auto role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, colours.disabled);
    return palette;
}

ThemeChoice readThemeChoice(const QSettings& settings) {
    const QString saved = settings.value(themeKey).toString();
    if (saved == QStringLiteral("light")) return ThemeChoice::light;
    return saved == QStringLiteral("dark") ? ThemeChoice::dark : ThemeChoice::system;
}

void saveThemeChoice(ThemeChoice choice, QSettings& settings) {
    const char* const names[] = {"system", "light", "dark"};
    settings.setValue(themeKey, QString::fromLatin1(names[int(choice)]));
}

void applyTheme(ThemeChoice choice, const QPalette& system) {
    const Theme theme = choice == ThemeChoice::system ? themeOf(system)
                        : choice == ThemeChoice::dark ? Theme::dark
                                                      : Theme::light;
    QApplication::setPalette(makePalette(theme));
}

NoteColours noteColours(Theme theme) {
    return theme == Theme::dark ? NoteColours{{0x1f, 0x3a, 0x52}, {0x3d, 0x6c, 0x93}, {0xd9, 0xe9, 0xf7}}
                                : NoteColours{{0xe4, 0xee, 0xf7}, {0x8f, 0xb2, 0xd1}, {0x15, 0x32, 0x4b}};
}

NoteColours errorColours(Theme theme) {
    return theme == Theme::dark ? NoteColours{{0x55, 0x26, 0x1c}, {0xa8, 0x55, 0x43}, {0xff, 0xdd, 0xd4}}
                                : NoteColours{{0xfb, 0xe4, 0xdf}, {0xd9, 0x80, 0x6c}, {0x5c, 0x16, 0x06}};
}

NoteColours warningColours(Theme theme) {
    return theme == Theme::dark ? NoteColours{{0x5a, 0x45, 0x12}, {0x9a, 0x78, 0x24}, {0xff, 0xe7, 0xb5}}
                                : NoteColours{{0xff, 0xd5, 0x8a}, {0xd9, 0xa0, 0x3a}, {0x1d, 0x20, 0x27}};
}

Inks inksOf(Theme theme) {
    if (theme == Theme::light) return {};
    return {darkColours.text, darkColours.quiet, {0x4a, 0x4f, 0x57}, darkColours.base};
}

void followTheme(QWidget& widget, std::function<void()> look) {
    look();
    new ThemeFollower(widget, std::move(look));
}

QColor errorTextColour(Theme theme) {
    return theme == Theme::dark ? QColor(0xff, 0xa3, 0x8f) : QColor(0xa0, 0x24, 0x10);
}

void showAsError(QLabel& label) {
    followTheme(label, [&label] {
        label.setStyleSheet(QStringLiteral("color: %1;").arg(errorTextColour(themeInUse()).name()));
    });
}

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
