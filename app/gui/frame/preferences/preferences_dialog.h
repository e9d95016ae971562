#pragma once

#include <QDialog>
#include <QObject>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QSettings;
class QAction;
class QWidget;

namespace noonmark {

/// What the user sets once for all projects: language, colours, units, paper, start page. Each is read and
/// saved by the functions that use it; the dialog stores nothing of its own. Applies on OK: colours at once,
/// language and units when the program starts again.
class PreferencesDialog final : public QDialog {
    Q_OBJECT
public:
    explicit PreferencesDialog(QSettings& settings, QWidget* parent = nullptr);  ///< must outlive it

Q_SIGNALS:
    void paperChosen();
    void textsChanged();  ///< another language or other units: all texts are to be written again

private:
    void addLooks(QFormLayout& form);
    void addUse(QFormLayout& form);
    void save();
    bool saveLooks();

    QSettings& settings_;
    QComboBox* language_;
    QComboBox* theme_;
    QComboBox* units_;
    QComboBox* paper_;
    QComboBox* orientation_;
    QCheckBox* start_;
};

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
