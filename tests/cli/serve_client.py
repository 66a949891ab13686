"""serve_client.py ADDRESS COMMAND [ARGUMENT]: talks to tessera serve as a browser does, and as one that means harm.

attack           requests that must be refused, none of which changes anything
state            prints NAME STATE FROM for each result
refine RESULT ACTION [PIECES [LOCK [SEED [DIGEST]]]]
                 begins a refinement and prints the status and the answer; lists are as in JSON, without brackets
wait             waits until no refinement runs, and prints the state of the last one with its message
stop             stops the running refinement
"""
import http.client
import json
import os
import sys
import time
from urllib.parse import urlsplit

address = urlsplit(sys.argv[1])
token = address.path.strip("/")
POST = {"X-Tessera": "1", "Content-Type": "application/json"}


def ask(method, path, body=None, headers=None, host=None):
    connection = http.client.HTTPConnection(address.hostname, address.port, timeout=60)
    connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
    connection.putheader("Host", host or address.netloc)
    for name, value in (headers or {}).items():
        connection.putheader(name, value)
    if body is not None:
        connection.putheader("Content-Length", str(len(body)))
    connection.endheaders()
    try:
        if body is not None:
            connection.send(body)
    except OSError:
        pass  # refused before its body was read
    answer = connection.getresponse()
    text = answer.read()
    assert "Access-Control-Allow-Origin" not in answer.headers, "another site may read this"
    return answer.status, text


def page(path):
    return f"/{token}/{path}"


def state():
    status, text = ask("GET", page("state"))
    assert status == 200, (status, text)
    return json.loads(text)["results"]


def expect(wanted, *request, **more):
    status, text = ask(*request, **more)
    assert status == wanted, f"{request[:2]} {more}: {status}, not {wanted}: {text[:200]}"
    return text


def attack():
    before = state()
    # Without the token, or with another one.
    for path in ["/", "/state", "/data?result=result", "//state", "/0/state", f"/{token[:-1]}/state", f"/{token}",
                 f"/{token}x/state", f"/x/../{token}/state", "/%2e%2e/" + token]:
        expect(404, "GET", path)
    expect(404, "POST", "/refine", b"{}", POST)
    # Other folders and files.
    for name in ["../result", "..", "/etc", ".", "result/..", "result%2F..%2Fdrawings", "drawings", "own.h5", "",
                 "result-99", "~", "%2e%2e"]:
        expect(400, "GET", page("data?result=" + name))
    for path in ["../state", "..%2fstate", "job.toml", "result/job.toml", "/etc/passwd", "%2e%2e/%2e%2e/etc/passwd", "state/x"]:
        expect(404, "GET", page(path))
    # Other sites, and names that lead here.
    for host in ["evil.example", "evil.example:80", "localhost.evil.example", "127.0.0.1.evil.example", "169.254.0.1", "[::2]"]:
        expect(403, "GET", page("state"), host=host)
        expect(403, "POST", page("refine"), b"{}", POST, host=host)
    for header in [{"Origin": "http://evil.example"}, {"Origin": "null"}, {"Sec-Fetch-Site": "cross-site"},
                   {"Sec-Fetch-Site": "same-site"}]:
        expect(403, "GET", page("state"), headers=header)
        expect(403, "POST", page("stop"), b"{}", POST | header)
    # Forms and other methods.
    expect(403, "POST", page("stop"), b"{}", {"Content-Type": "application/json"})
    expect(415, "POST", page("stop"), b"a=b", {"X-Tessera": "1", "Content-Type": "application/x-www-form-urlencoded"})
    for method in ["PUT", "DELETE", "OPTIONS", "TRACE", "PATCH"]:
        expect(405, method, page("state"))
    expect(404, "GET", page("refine"))
    expect(404, "POST", page("state"), b"{}", POST)
    # Bodies.
    order = {"result": "result", "pieces_digest": "0", "action": "erase", "pieces": [0], "lock": [], "seed": None}
    for body in [b"", b"[]", b"{", b"\xff\x00", b"[" * 100_000, *(json.dumps(order | change).encode() for change in [
            {"pieces": []}, {"result": "../result"}, {"lock": ["--out=x"]}, {"seed": "1 --out x"}, {"action": "-x"},
            {"pieces_digest": None}])]:
        expect(400, "POST", page("refine"), body, POST)
    expect(409, "POST", page("refine"), json.dumps(order).encode(), POST)  # the pieces of another result
    expect(413, "POST", page("refine"), b"x" * 9_000_000, POST)
    assert state() == before, "a refused request has changed something"


def wait():
    until = time.monotonic() + 100
    while any(result["state"] == "running" for result in state()):
        assert time.monotonic() < until, "it does not end"
        time.sleep(0.05)
    last = state()[-1]
    print(last["name"], last["state"], last["message"])


def refine(result, action, pieces="", lock="", seed="null", digest=None):
    if digest is None:
        with open(f"{result}/manifest.json", encoding="utf-8") as file:
            digest = json.load(file)["pieces"]["digest"]
    body = {"result": os.path.basename(result), "pieces_digest": digest, "action": action, "pieces": json.loads(f"[{pieces}]"),
            "lock": json.loads(f"[{lock}]"), "seed": json.loads(seed)}
    status, text = ask("POST", page("refine"), json.dumps(body).encode(), POST)
    print(status, text.decode())


commands = {"attack": attack, "wait": wait, "refine": refine,
            "state": lambda: [print(r["name"], r["state"], r["from"] or "-") for r in state()],
            "stop": lambda: expect(200, "POST", page("stop"), b"{}", POST)}
commands[sys.argv[2]](*sys.argv[3:])
