#pragma once
// What the list of kept orders asks for, done to the case: keep, drop, compare; each is one step of undo.

#include "widgets/rehearse/kept_orders.h"
#include "widgets/workspaces/workspace.h"

namespace glisson::widgets {

void connect_orders(KeptOrders& orders, const WorkspaceContext& context);
// Reads them anew from the case of the patient shown.
void show_kept_orders(KeptOrders& orders, const WorkspaceContext& context);

}  // namespace glisson::widgets
