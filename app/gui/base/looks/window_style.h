#pragma once

#include <QProxyStyle>

namespace noonmark {

/// Qt's style Fusion, with what it lacks on dark windows: outlines of check boxes and radio buttons. Buttons
/// of dialogs have no icons, which Fusion draws for light windows only. Names of tabs are never cut.
class WindowStyle final : public QProxyStyle {
    Q_OBJECT
public:
    WindowStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* answer) const override;
};

}  // namespace noonmark
