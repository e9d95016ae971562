#pragma once

#include <QObject>

class QAction;
class QSettings;
class QWidget;

namespace noonmark {

/// The entry Preferences of the menu Edit.
class PreferencesActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    PreferencesActions(QSettings& settings, QWidget& window);

    [[nodiscard]] QAction* action() const { return show_; }

Q_SIGNALS:
    void paperChosen();
    void textsChanged();  ///< the language or the units are others

private:
    void show();

    QSettings& settings_;
    QWidget& window_;
    QAction* show_;
};

}  // namespace noonmark
