#pragma once

#include <QObject>

#include "app/window/frame/recent_files.h"

class QMenu;

namespace noonmark {

/// The menu of what was opened lately; what was read with settings of its own says so and gets them again.
class RecentMenu final : public QObject {
    Q_OBJECT
public:
    RecentMenu(QMenu& menu, QSettings& settings);  ///< both outlive it
    void add(const QStringList& files, const ReadSettings& reading = {});

Q_SIGNALS:
    void chosen(QStringList files, noonmark::ReadSettings reading);

private:
    void fill();
    QMenu& menu_;
    RecentFiles recent_;
};

}  // namespace noonmark
