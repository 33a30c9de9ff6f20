#pragma once
// Where an archive is: for those who open archives and need not know the room below.

#include "engine/database/archive_url.h"
