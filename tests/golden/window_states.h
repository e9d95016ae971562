#pragma once

#include <QSettings>
#include <QStringList>
#include <QTemporaryDir>

#include "app/gui/frame/main_window.h"

namespace noonmark::golden {

/// Brings the window with a small project into one state after another by the widgets that a user takes, and
/// writes what it says in each as a text file.
class WindowStates {
public:
    explicit WindowStates(QString folder);  ///< the files' folder
    void writeAll();

private:
    void makeProject();
    void open();
    void study();
    void compare();
    void score();
    void measurePoints();
    void measurePlaces();
    void inspectPoint();
    void review();
    void reviewGlazing();
    void fillScenarioTable();
    void saveAndReopen();
    void showSavedResults(const char* state);
    void changeSettings();
    void changeBuildings();
    void showDialogs();

    void choose(const char* list, const QString& entry);
    void press(const char* button);
    void trigger(const QString& action);
    void enter(const QString& group, const QString& name);
    [[nodiscard]] QModelIndex nodeOf(const QString& group, const QString& name);
    template <class T>
    T& named(const char* name);

    void exportTo(const char* name, int subject = 0);

    void settle();
    void rest();
    void listenToMessages();
    void write(const char* name);
    void writeText(const QString& name, const QString& text) const;

    QString folder_;
    QTemporaryDir work_;
    QString file_ = work_.filePath(QStringLiteral("small.noonmark.gpkg"));
    QSettings settings_{work_.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    std::unique_ptr<MainWindow> window_;
    QStringList messages_;  ///< since the last state; notes leave by themselves
    int written_ = 0;
};

}  // namespace noonmark::golden
