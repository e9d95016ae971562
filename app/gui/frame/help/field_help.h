#pragma once

#include <QObject>
#include <functional>

#include "app/gui/frame/help/guide_window.h"

class QWidget;

namespace noonmark {

/// Whether a widget takes input: a number, a text, a choice, a switch, a slider, a list or a button.
bool isField(const QWidget& widget);

/// The text of "What's this" for a field as HTML: its label, what it means (its tool tip, or a text of its
/// own in field_help.cpp), range and unit, and a link to the guide (guideLink()). Empty where nothing is
/// known.
QString describeField(const QWidget& field);

/// "What's this" for all windows of the application: texts are made when they are asked for, so that fields
/// that come later have theirs too. Shift+F1 explains the focused field; F1 and the links in these texts open
/// the guide, in dialogs too.
class FieldHelp final : public QObject {
    Q_OBJECT
public:
    using ShowGuide = std::function<void(const GuidePlace&)>;
    explicit FieldHelp(ShowGuide showGuide, QObject* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool openGuide(const QObject& watched);

    ShowGuide showGuide_;
};

}  // namespace noonmark
