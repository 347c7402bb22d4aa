/* Who is at the other end of a loopback connection. */
#ifndef BATTEN_APPS_PEER_H
#define BATTEN_APPS_PEER_H

#include <netinet/in.h>
#include <stdbool.h>

/*
 * False when the process that connects to our port belongs to another user (except the superuser, who can do
 * anything anyway): a loopback address is open to everybody on the machine, and the page contains the token. Also
 * true when the system does not say.
 */
bool peer_is_ours(const struct sockaddr_in *peer, int port);

#endif
