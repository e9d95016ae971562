#pragma once

#include <QObject>

class QAction;
class QSettings;
class QWidget;

namespace noonmark {

class MessageBar;

/// The entry Preferences of the menu Edit.
class PreferencesActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    PreferencesActions(QSettings& settings, MessageBar& messages, QWidget& window);

    [[nodiscard]] QAction* action() const { return show_; }

Q_SIGNALS:
    void paperChosen();

private:
    void show();

    QSettings& settings_;
    MessageBar& messages_;
    QWidget& window_;
    QAction* show_;
};

}  // namespace noonmark
