#pragma once

#include <QString>

class QWidget;

namespace noonmark {

/// Where the guide describes a part of the window.
struct GuidePlace {
    QString page;     ///< a name of listGuidePages()
    QString section;  ///< a heading of the page; empty: its beginning
};

/// The place of the nearest dock, dialog or bar that the widget lies in; the page "window" for everything
/// else and for null.
GuidePlace findGuidePlace(const QWidget* widget);

/// "guide:PAGE#SECTION", as links of What's this name it, and back.
QString guideLink(const GuidePlace& place);
GuidePlace parseGuideLink(const QString& link);

}  // namespace noonmark
