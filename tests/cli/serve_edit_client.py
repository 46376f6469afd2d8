"""Makes a failure known as the page of `orbs serve --edit` does: serve_edit_client.py URL RENDERER TARGET REASON UNTIL.
Prints the answer to the request that shows the difference, and of the one that confirms it."""
import json
import sys
import urllib.error
import urllib.request

address, renderer, target, reason, until = sys.argv[1:]
server, token = address.split("/#edit=")


def ask(**more):
    body = {"run": 0, "target": target, "renderer": renderer, "reason": reason, "until": until, **more}
    headers = {"Origin": server, "Orbs-Token": token, "Content-Type": "application/json"}
    request = urllib.request.Request(f"{server}/edit/known-failure", json.dumps(body).encode(), headers)
    try:
        with urllib.request.urlopen(request, timeout=20) as answer:
            return json.load(answer)
    except urllib.error.HTTPError as error:
        print(error.code, error.read().decode())
        sys.exit(1)


shown = ask()
print(shown["diff"])
written = ask(hash=shown["hash"])
print(f'{written["file"]}:{written["line"]} {written["written"]}')
