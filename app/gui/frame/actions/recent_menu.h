#pragma once

#include <QObject>

#include "app/gui/session/project/recent_files.h"

class QMenu;

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

}  // namespace noonmark
