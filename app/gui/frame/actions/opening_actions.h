#pragma once

#include <QMenu>
#include <QObject>

#include "app/gui/session/project/recent_files.h"

class QMenu;
class QSettings;

namespace noonmark {

/// The menu of recent files. An entry read with its own settings is labelled, and opens with them again.
class RecentMenu final : public QObject {
    Q_OBJECT
public:
    RecentMenu(QMenu& menu, QSettings& settings);  ///< both must outlive it
    void add(const QStringList& files, const ReadSettings& reading = {});
    [[nodiscard]] QString newest() const { return recent_.entries().value(0); }
    void setPicture(const QString& entry, const QImage& picture) { recent_.setPicture(entry, picture); }

Q_SIGNALS:
    void chosen(QStringList files, noonmark::ReadSettings reading);

private:
    void fill();
    QMenu& menu_;
    RecentFiles recent_;
};

class MessageBar;
class OpenOptions;
class SavingActions;
class Workbench;

/// Opens cities, samples, recent files and projects, and offers to open them again with options where they
/// do not state everything.
class OpeningActions final : public QObject {
    Q_OBJECT
public:
    /// `settings` stores the recent files; dialogs belong to `window`. All must outlive this object.
    OpeningActions(Workbench& workbench, SavingActions& saving, QSettings& settings, MessageBar& messages,
                   QWidget& window);

    /// New project, open, open with options, samples, recent files.
    [[nodiscard]] QList<QAction*> actions() const;
    [[nodiscard]] QAction* openAction() const { return actions_[1]; }

    /// Asks first if there is unsaved work, and whether a terrain alone belongs to the city that is open.
    void open(const QStringList& files);
    void openFolder();  ///< asks for one: its city files, or what it is itself
    /// Terrains that lay in the folder which was opened last and are not in the city: listed, and offered.
    [[nodiscard]] QStringList terrainsBeside() const;
    /// Reads the city again with these terrains, unless it has one.
    void addTerrain(const QStringList& files, const ReadSettings& reading = {});
    void openFilesOf(const QString& folder);
    void openWith(const QStringList& files, const ReadSettings& reading);
    void takeProject();  ///< another project is open: adds it to the recent files
    void showGuesses();  ///< reports what is assumed because the files do not state it: heights, time zone

    /// The entry of the recent files that is open, and a picture of the view to keep with it.
    [[nodiscard]] QString recentEntry() const { return recent_.newest(); }
    void storePicture(const QString& entry, const QImage& picture) { recent_.setPicture(entry, picture); }

Q_SIGNALS:
    void openingStarted();      ///< files are being opened, and nothing is left to ask
    void opened();              ///< another project is open
    void wholeCityRequested();  ///< to see buildings that the first view leaves aside

private:
    void makeActions();
    void replaceBy(const QStringList& files, const ReadSettings& reading);
    [[nodiscard]] bool canAddTerrain() const;
    void askAboutTerrain(const QStringList& files, const ReadSettings& reading);
    void addSample(const QString& text, const QString& tip, const QString& sample);
    void showFailure(const Error& error);
    void offerOptions();
    void chooseTerrain();
    [[nodiscard]] QStringList describeGuesses() const;
    [[nodiscard]] QString describeReading() const;

    Workbench& workbench_;
    SavingActions& saving_;
    MessageBar& messages_;
    QWidget& window_;
    QMenu samples_;
    QMenu recentMenu_;
    RecentMenu recent_;
    OpenOptions* options_;
    QList<QAction*> actions_;
    QStringList filesOfFolder_;
    QStringList terrainsOfFolder_;
};

}  // namespace noonmark
